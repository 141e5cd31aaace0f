package robotran.hub.model

import robotran.brick.controls.MotorPort

/** The ports of all hubs, by what is printed beside them. A port with a letter takes motors. */
enum class HubPort {
    A,
    B,
    C,
    D,
    E,
    F,
    S1,
    S2,
    S3,
    S4,
    ;

    /** The same as an output of a brick; null for a port that takes sensors alone. */
    val motorPort: MotorPort? get() = MotorPort.entries.getOrNull(ordinal)

    companion object {
        fun of(port: MotorPort): HubPort = entries[port.ordinal]
    }
}
