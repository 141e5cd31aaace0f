package robotran.tower.port

/** How an infrared tower is connected. */
enum class TowerKind {
    /** A serial port, or a serial adapter. The tower hears what it sends: every byte comes back first. */
    SERIAL,

    /** LEGO's USB tower, vendor 0694, product 0001. It does not hear itself. */
    USB,
}

/**
 * A tower that can be opened.
 *
 * @property id what [TowerPorts.open] needs to find it, such as `COM3`. It is only valid for the platform that gave it.
 * @property name the name that the system shows for it; may be empty.
 */
data class TowerDevice(val id: String, val name: String, val kind: TowerKind)
