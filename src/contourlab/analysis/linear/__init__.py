"""Linear loops as they are sampled: poles, margins, responses, and linear designs."""
