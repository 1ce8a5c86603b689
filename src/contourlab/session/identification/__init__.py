"""The models of ``contourlab identify``, one file each; `contourlab.session.identification.register` names them."""
