package robotran.rcxrom.controls

/** The four buttons on the brick's face. */
enum class BrickButton { ON_OFF, VIEW, PRGM, RUN }
