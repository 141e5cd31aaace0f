package robotran.brick.controls

enum class MotorPort { A, B, C }
