package robotran.brick.kind

/** How a program gets from this app to a real brick. */
enum class ProgramUpload {
    /** As infrared light from a tower, as an image or with LEGO's firmware. */
    TOWER,

    /** Over Bluetooth or USB, to a hub with Pybricks. */
    HUB,

    /** As a `.hex` or over USB, to a micro:bit with MicroPython. */
    MICROBIT,

    /** Not from this app: it makes a kit of files that other tools send. */
    NONE,
}
