package robotran.brick.kind

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorPort
import robotran.brick.controls.PowerUnit
import robotran.brick.log.CallGroup
import robotran.brick.sensors.SensorCase
import robotran.brick.sensors.SensorKind

/**
 * The kinds of bricks that a robot can have. A row is the registration of a brick: whoever wants to know what a brick
 * can do asks for a fact of its row, never which kind it is. What a module has for each kind is in one file of that module.
 *
 * @property label what people call it.
 * @property motorPorts its ports for motors, in their order.
 * @property inputPorts number of ports for sensors, numbered from 1.
 * @property hasLetteredInputs whether those have letters on the brick, A for 1, and take motors as well.
 * @property sensors those that it can read.
 * @property ownSensors those that are built into it, on no port.
 * @property sensorsOnPort how many of them fit on one port, one on the other.
 * @property sensorCase what its simple sensors are built into.
 * @property readsInUnits whether it tells what a sensor measures in the unit of that sensor, whatever the program chose.
 * @property buttons in the order of its manual.
 * @property startButton starts the selected program.
 * @property powerUnit what the power of a motor is counted in.
 * @property hasMotorCounters whether it counts the degrees that its motors turn.
 * @property measuresBattery whether programs can ask for its voltage.
 * @property chartsBattery whether charts show the voltage that it measures.
 * @property displayRows the number of rows of text on its display.
 * @property hasInfrared whether it sends and receives messages by infrared light without a sensor for them.
 * @property hasSoftSound whether it plays samples, so that a tone is a sine and no square wave.
 * @property hasRom whether programs act through the ROM in its memory, which can be looked at.
 * @property callGroups the subjects of the calls in its log.
 * @property java what runs programs in Java on it; null if nothing does.
 * @property hasLegoFirmware whether programs for LEGO's own firmware run on it.
 * @property programUpload how programs get to a real one.
 * @property takesAn whether English says "an" before its [label], as in "an RCX".
 */
enum class BrickKind(
    val label: String,
    val motorPorts: List<MotorPort>,
    val inputPorts: Int,
    val hasLetteredInputs: Boolean,
    val sensors: Set<SensorKind>,
    val ownSensors: Set<SensorKind>,
    val sensorsOnPort: Int,
    val sensorCase: SensorCase,
    val readsInUnits: Boolean,
    val buttons: List<BrickButton>,
    val startButton: BrickButton,
    val powerUnit: PowerUnit,
    val hasMotorCounters: Boolean,
    val measuresBattery: Boolean,
    val chartsBattery: Boolean,
    val displayRows: Int,
    val hasInfrared: Boolean,
    val hasSoftSound: Boolean,
    val hasRom: Boolean,
    val callGroups: List<CallGroup>,
    val java: JavaPlatform?,
    val hasLegoFirmware: Boolean,
    val programUpload: ProgramUpload,
    private val takesAn: Boolean = false,
) {
    /** LEGO's brick of 1998, with leJOS. */
    RCX(
        label = "RCX",
        motorPorts = listOf(MotorPort.A, MotorPort.B, MotorPort.C),
        inputPorts = 3,
        hasLetteredInputs = false,
        sensors = setOf(SensorKind.TOUCH, SensorKind.LIGHT, SensorKind.TEMPERATURE, SensorKind.ROTATION),
        ownSensors = emptySet(),
        sensorsOnPort = 2,
        sensorCase = SensorCase.STUDDED,
        readsInUnits = false,
        buttons = listOf(BrickButton.ON_OFF, BrickButton.VIEW, BrickButton.PRGM, BrickButton.RUN),
        startButton = BrickButton.RUN,
        powerUnit = PowerUnit.STEPS,
        hasMotorCounters = false,
        measuresBattery = true,
        chartsBattery = false,
        displayRows = 1,
        hasInfrared = true,
        hasSoftSound = false,
        hasRom = true,
        callGroups = CallGroup.COMMON + listOf(CallGroup.INFRARED, CallGroup.TIMER, CallGroup.UNKNOWN),
        java = JavaPlatform.LEJOS,
        hasLegoFirmware = true,
        programUpload = ProgramUpload.TOWER,
        takesAn = true,
    ),

    /** LEGO's brick of 2006, with leJOS NXJ. */
    NXT(
        label = "NXT",
        motorPorts = listOf(MotorPort.A, MotorPort.B, MotorPort.C),
        inputPorts = 4,
        hasLetteredInputs = false,
        sensors = SensorKind.entries.toSet(),
        ownSensors = emptySet(),
        sensorsOnPort = 1,
        sensorCase = SensorCase.ROUNDED,
        readsInUnits = true,
        buttons = listOf(BrickButton.ENTER, BrickButton.LEFT, BrickButton.RIGHT, BrickButton.ESCAPE),
        startButton = BrickButton.ENTER,
        powerUnit = PowerUnit.PERCENT,
        hasMotorCounters = true,
        measuresBattery = true,
        chartsBattery = true,
        displayRows = 8,
        hasInfrared = false,
        hasSoftSound = true,
        hasRom = false,
        callGroups = CallGroup.COMMON + listOf(CallGroup.BLUETOOTH, CallGroup.SYSTEM),
        java = JavaPlatform.NXJ,
        hasLegoFirmware = false,
        programUpload = ProgramUpload.NONE,
        takesAn = true,
    ),

    /** The hub of SPIKE Prime and Robot Inventor, with Pybricks; so are those below. */
    SPIKE_PRIME(
        label = "SPIKE Prime",
        motorPorts = MotorPort.entries,
        inputPorts = 6,
        hasLetteredInputs = true,
        sensors = POWERED_UP_SENSORS,
        buttons = listOf(BrickButton.LEFT, BrickButton.ENTER, BrickButton.RIGHT, BrickButton.BLUETOOTH),
        displayRows = 1,
    ),
    SPIKE_ESSENTIAL(
        label = "SPIKE Essential",
        motorPorts = MotorPort.entries.take(2),
        inputPorts = 2,
        hasLetteredInputs = true,
        sensors = POWERED_UP_SENSORS,
        buttons = listOf(BrickButton.ENTER),
        displayRows = 0,
    ),
    TECHNIC_HUB(
        label = "Technic Hub",
        motorPorts = MotorPort.entries.take(4),
        inputPorts = 4,
        hasLetteredInputs = true,
        sensors = POWERED_UP_SENSORS,
        buttons = listOf(BrickButton.ENTER),
        displayRows = 0,
    ),
    EV3(
        label = "EV3",
        motorPorts = MotorPort.entries.take(4),
        inputPorts = 4,
        hasLetteredInputs = false,
        sensors = POWERED_UP_SENSORS,
        buttons = listOf(
            BrickButton.LEFT,
            BrickButton.ENTER,
            BrickButton.RIGHT,
            BrickButton.UP,
            BrickButton.DOWN,
            BrickButton.ESCAPE,
        ),
        displayRows = 8,
        takesAn = true,
    ),
    NXT_PYBRICKS(
        label = "NXT with Pybricks",
        motorPorts = MotorPort.entries.take(3),
        inputPorts = 4,
        hasLetteredInputs = false,
        sensors = POWERED_UP_SENSORS + SensorKind.LIGHT + SensorKind.SOUND,
        buttons = listOf(BrickButton.LEFT, BrickButton.ENTER, BrickButton.RIGHT, BrickButton.ESCAPE),
        displayRows = 8,
        takesAn = true,
    ),

    /** A BBC micro:bit V2 with MicroPython, on a buggy; the one below is its forerunner without loudspeaker and microphone. */
    MICROBIT(
        label = "micro:bit",
        buttons = listOf(BrickButton.ENTER, BrickButton.RIGHT, BrickButton.ESCAPE),
        ownSensors = setOf(SensorKind.SOUND),
    ),
    MICROBIT_V1(
        label = "micro:bit V1",
        buttons = listOf(BrickButton.ENTER, BrickButton.RIGHT),
        ownSensors = emptySet(),
    ),
    ;

    /** A hub with Pybricks. */
    constructor(
        label: String,
        motorPorts: List<MotorPort>,
        inputPorts: Int,
        hasLetteredInputs: Boolean,
        sensors: Set<SensorKind>,
        buttons: List<BrickButton>,
        displayRows: Int,
        takesAn: Boolean = false,
    ) : this(
        label,
        motorPorts,
        inputPorts,
        hasLetteredInputs,
        sensors,
        ownSensors = emptySet(),
        sensorsOnPort = 1,
        SensorCase.ROUNDED,
        readsInUnits = true,
        buttons,
        startButton = BrickButton.ENTER,
        PowerUnit.PERCENT,
        hasMotorCounters = true,
        measuresBattery = true,
        chartsBattery = true,
        displayRows,
        hasInfrared = false,
        hasSoftSound = true,
        hasRom = false,
        callGroups = CallGroup.COMMON + CallGroup.SYSTEM,
        java = null,
        hasLegoFirmware = false,
        ProgramUpload.HUB,
        takesAn,
    )

    /** A micro:bit on a buggy, whose motors are A left, C right and B for the pen. */
    constructor(label: String, buttons: List<BrickButton>, ownSensors: Set<SensorKind>) : this(
        label,
        motorPorts = listOf(MotorPort.A, MotorPort.B, MotorPort.C),
        inputPorts = 4,
        hasLetteredInputs = false,
        sensors = setOf(SensorKind.LIGHT, SensorKind.ULTRASONIC),
        ownSensors,
        sensorsOnPort = 1,
        SensorCase.ROUNDED,
        readsInUnits = true,
        buttons,
        startButton = BrickButton.ENTER,
        PowerUnit.PERCENT,
        hasMotorCounters = false,
        measuresBattery = false,
        chartsBattery = false,
        displayRows = 1,
        hasInfrared = false,
        hasSoftSound = false,
        hasRom = false,
        callGroups = CallGroup.COMMON + CallGroup.SYSTEM,
        java = null,
        hasLegoFirmware = false,
        ProgramUpload.MICROBIT,
    )

    /** Whether it is a micro:bit, which drives as the buggy does that it is plugged into. */
    val isOnBuggy: Boolean get() = programUpload == ProgramUpload.MICROBIT

    /** What it is called on the command line. */
    val word: String get() = name.lowercase().replace('_', '-')

    /** Its [label] in an English sentence: "an RCX", "a SPIKE Prime". */
    val withArticle: String get() = (if (takesAn) "an " else "a ") + label

    /** What is printed beside the port for sensors with this [number], from 1. */
    fun inputLabel(number: Int): String = if (hasLetteredInputs) MotorPort.entries[number - 1].name else "$number"

    companion object {
        /**
         * The brick where none is named: of a new project, of a robot in a file that names none, and of a program that
         * runs on any. File formats mean it, so it stays.
         */
        val default: BrickKind = RCX

        /** The brick that runs programs for LEGO's own firmware. */
        val ofLegoFirmware: BrickKind = entries.single { it.hasLegoFirmware }

        /** The buttons that any brick has, in the order of [BrickButton]. */
        val allButtons: List<BrickButton> = BrickButton.entries.filter { button ->
            entries.any { button in it.buttons }
        }

        /** The brick with this [java]. */
        fun with(java: JavaPlatform): BrickKind = entries.single { it.java == java }

        /** The brick whose programs in Java name packages in [root], such as `lejos`; null if there is none. */
        fun ofJavaRoot(root: String): BrickKind? = entries.firstOrNull { it.java?.root == root }
    }
}

/** What a hub reads with Pybricks that all of them read. */
private val POWERED_UP_SENSORS: Set<SensorKind>
    get() = setOf(SensorKind.TOUCH, SensorKind.COLOUR, SensorKind.ULTRASONIC)
