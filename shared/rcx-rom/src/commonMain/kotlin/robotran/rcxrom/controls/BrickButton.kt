package robotran.rcxrom.controls

enum class BrickButton { ON_OFF, VIEW, PRGM, RUN }
