package robotran.brick.kind

enum class BrickKind(val inputPorts: Int) { RCX(3), NXT(4) }
