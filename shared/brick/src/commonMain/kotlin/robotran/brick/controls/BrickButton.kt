package robotran.brick.controls

enum class BrickButton { ON_OFF, VIEW, PRGM, RUN }
