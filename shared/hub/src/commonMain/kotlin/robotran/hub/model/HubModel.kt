package robotran.hub.model

import robotran.brick.kind.BrickKind

/**
 * The hubs that run programs with Pybricks. A row holds the facts of a hub.
 *
 * @property kind the same among all bricks.
 * @property className its class in `pybricks.hubs`.
 * @property devices its motors and sensors in Pybricks.
 * @property motorPorts the ports for motors.
 * @property sensorPorts the ports for sensors, in the order of their numbers in other languages, from 1.
 * @property hasMatrix whether it has 5 by 5 lights.
 * @property columns of characters on its screen; 0 without one.
 * @property rows of characters on its screen; 0 without one.
 * @property hasSpeaker whether it has a loudspeaker.
 * @property lights the colours of its status light; empty without one.
 * @property buttons those that it has.
 * @property stopButton the one that stops a program until a program says otherwise.
 * @property hasGyro whether it tells where it is heading.
 * @property slots how many programs it keeps.
 * @property memoryBytes room for a running program and its values.
 * @property motor the motors of its sets.
 * @property fullMillivolts its voltage when its battery is full.
 */
enum class HubModel(
    val kind: BrickKind,
    val className: String,
    val devices: HubDevices,
    val motorPorts: List<HubPort>,
    val sensorPorts: List<HubPort>,
    val hasMatrix: Boolean,
    val columns: Int,
    val rows: Int,
    val hasSpeaker: Boolean,
    val lights: List<HubColor>,
    val buttons: List<HubButton>,
    val stopButton: HubButton,
    val hasGyro: Boolean,
    val slots: Int,
    val memoryBytes: Int,
    val motor: HubMotorKind,
    val fullMillivolts: Int,
) {
    /** Also the hub of Robot Inventor, which has the same parts. */
    SPIKE_PRIME(
        kind = BrickKind.SPIKE_PRIME,
        className = "PrimeHub",
        devices = HubDevices.POWERED_UP,
        motorPorts = LETTERS,
        sensorPorts = LETTERS,
        hasMatrix = true,
        columns = 0,
        rows = 0,
        hasSpeaker = true,
        lights = ANY_COLOR,
        buttons = listOf(HubButton.LEFT, HubButton.CENTER, HubButton.RIGHT, HubButton.BLUETOOTH),
        stopButton = HubButton.CENTER,
        hasGyro = true,
        slots = 5,
        memoryBytes = 270_000,
        motor = HubMotorKind.MEDIUM,
        fullMillivolts = 8_300,
    ),
    SPIKE_ESSENTIAL(
        kind = BrickKind.SPIKE_ESSENTIAL,
        className = "EssentialHub",
        devices = HubDevices.POWERED_UP,
        motorPorts = LETTERS.take(2),
        sensorPorts = LETTERS.take(2),
        hasMatrix = false,
        columns = 0,
        rows = 0,
        hasSpeaker = false,
        lights = ANY_COLOR,
        buttons = listOf(HubButton.CENTER),
        stopButton = HubButton.CENTER,
        hasGyro = true,
        slots = 1,
        memoryBytes = 256_000,
        motor = HubMotorKind.SMALL,
        fullMillivolts = 8_300,
    ),
    TECHNIC_HUB(
        kind = BrickKind.TECHNIC_HUB,
        className = "TechnicHub",
        devices = HubDevices.POWERED_UP,
        motorPorts = LETTERS.take(4),
        sensorPorts = LETTERS.take(4),
        hasMatrix = false,
        columns = 0,
        rows = 0,
        hasSpeaker = false,
        lights = ANY_COLOR,
        buttons = listOf(HubButton.CENTER),
        stopButton = HubButton.CENTER,
        hasGyro = true,
        slots = 1,
        memoryBytes = 32_000,
        motor = HubMotorKind.MEDIUM,
        fullMillivolts = 9_000,
    ),
    EV3(
        kind = BrickKind.EV3,
        className = "EV3Brick",
        devices = HubDevices.EV3,
        motorPorts = LETTERS.take(4),
        sensorPorts = NUMBERS,
        hasMatrix = false,
        columns = 22,
        rows = 8,
        hasSpeaker = true,
        lights = listOf(HubColor.RED, HubColor.GREEN, HubColor.ORANGE),
        buttons = listOf(
            HubButton.LEFT,
            HubButton.CENTER,
            HubButton.RIGHT,
            HubButton.UP,
            HubButton.DOWN,
            HubButton.BACK,
        ),
        stopButton = HubButton.BACK,
        hasGyro = false,
        slots = 4,
        memoryBytes = 1_000_000,
        motor = HubMotorKind.EV3_LARGE,
        fullMillivolts = 8_000,
    ),
    NXT_PYBRICKS(
        kind = BrickKind.NXT_PYBRICKS,
        className = "NXTBrick",
        devices = HubDevices.NXT,
        motorPorts = LETTERS.take(3),
        sensorPorts = NUMBERS,
        hasMatrix = false,
        columns = 16,
        rows = 8,
        hasSpeaker = true,
        lights = emptyList(),
        buttons = listOf(HubButton.LEFT, HubButton.CENTER, HubButton.RIGHT, HubButton.BACK),
        stopButton = HubButton.BACK,
        hasGyro = false,
        slots = 1,
        memoryBytes = 10_000,
        motor = HubMotorKind.NXT,
        fullMillivolts = 8_000,
    ),
    ;

    /** Whether it shows rows of text. */
    val hasScreen: Boolean get() = rows > 0

    /** All its ports. */
    val ports: List<HubPort> get() = (motorPorts + sensorPorts).distinct()

    /** Whether the left motor of its usual driving base turns the other way round. */
    val mirrorsLeft: Boolean get() = kind.hasLetteredInputs

    companion object {
        /** The hub of this kind; null if [kind] is none. */
        fun of(kind: BrickKind): HubModel? = entries.find { it.kind == kind }
    }
}

private val LETTERS: List<HubPort> get() = listOf(HubPort.A, HubPort.B, HubPort.C, HubPort.D, HubPort.E, HubPort.F)
private val NUMBERS: List<HubPort> get() = listOf(HubPort.S1, HubPort.S2, HubPort.S3, HubPort.S4)
private val ANY_COLOR: List<HubColor> get() = HubColor.entries - HubColor.NONE - HubColor.BLACK
