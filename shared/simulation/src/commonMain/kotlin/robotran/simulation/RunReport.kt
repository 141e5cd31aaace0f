package robotran.simulation

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.place
import robotran.brick.sensors.SensorKind
import robotran.brick.state.RunState
import robotran.simulation.messages.ShortfallMessages
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.MissingSensor
import robotran.world.Thousandths
import robotran.world.roundToThousandths

/**
 * The result of a run, for people and programs. Lengths are in centimetres; numbers are rounded to thousandths.
 *
 * @property seconds virtual time since the session began.
 * @property lcd the display's content in plain text; of an NXT whose program has ended, as the program left it.
 * @property traceHash a hash of the robot's pose in every tick and of every logged call; the same on every platform.
 * @property error what went wrong in one sentence, null unless [status] is [RunStatus.FAILED].
 * @property goals the results of the world's goals.
 * @property missingSensors what the program expects at the ports, but the robot does not have there; omitted if nothing.
 * @property screen the lines of the display of an NXT, as for [lcd]; omitted for an RCX.
 */
@Serializable
data class RunReport(
    val status: RunStatus,
    val seconds: Thousandths,
    val pose: ReportedPose,
    val inkCentimetres: Thousandths,
    val bumps: Int,
    val lcd: String,
    val romCalls: Int,
    val traceHash: String,
    val error: String?,
    val goals: List<GoalReport>,
    val missingSensors: List<ReportedSensor> = emptyList(),
    val screen: List<String> = emptyList(),
) {
    /** The report as JSON, with its fields in the order above. */
    fun toJson(): String = reportJson.encodeToString(serializer(), this)
}

/** The status of a run. */
@Serializable
enum class RunStatus {
    /** The program ended or was stopped, or none was started. */
    @SerialName("ended")
    ENDED,

    @SerialName("running")
    RUNNING,

    @SerialName("failed")
    FAILED,
}

/**
 * A [MissingSensor] in a report.
 *
 * @property port from 1.
 * @property remark the sentence that the pupil reads.
 */
@Serializable
data class ReportedSensor(val port: Int, val sensor: ReportedSensorKind, val remark: String)

/** [SensorKind] in a report. */
@Serializable
enum class ReportedSensorKind {
    @SerialName("touch")
    TOUCH,

    @SerialName("temperature")
    TEMPERATURE,

    @SerialName("light")
    LIGHT,

    @SerialName("rotation")
    ROTATION,

    @SerialName("ultrasonic")
    ULTRASONIC,

    @SerialName("sound")
    SOUND,

    @SerialName("colour")
    COLOUR,

    @SerialName("compass")
    COMPASS,

    @SerialName("gyro")
    GYRO,

    @SerialName("hitechnic colour")
    HITECHNIC_COLOUR,

    @SerialName("mindsensors compass")
    MINDSENSORS_COMPASS,

    @SerialName("hitechnic acceleration")
    HITECHNIC_ACCELERATION,

    @SerialName("mindsensors acceleration")
    MINDSENSORS_ACCELERATION,

    @SerialName("rcx light")
    RCX_LIGHT,

    @SerialName("rcx link")
    RCX_LINK,

    @SerialName("optical distance")
    OPTICAL_DISTANCE,

    @SerialName("nxt temperature")
    NXT_TEMPERATURE,

    @SerialName("infrared seeker")
    INFRARED_SEEKER,

    @SerialName("infrared seeker 2")
    INFRARED_SEEKER_2,
}

/** A [Pose] in a report; [heading] in degrees counter-clockwise from the x axis. */
@Serializable
data class ReportedPose(val x: Thousandths, val y: Thousandths, val heading: Thousandths)

/**
 * The result of a goal of the world.
 *
 * @property goal the sentence that the pupil reads.
 * @property progress 0..1; 1 only if the goal was met.
 * @property parts the results of its subgoals; omitted if there are none.
 * @property shortfall what the run lacked; omitted if the goal was met or may still be met.
 */
@Serializable
data class GoalReport(
    val goal: String,
    val met: Boolean,
    val status: GoalReportStatus,
    val progress: Thousandths,
    val parts: List<GoalReport> = emptyList(),
    val shortfall: ReportedShortfall? = null,
) {
    companion object {
        /** @param messages the words for what the run lacked. */
        fun of(progress: GoalProgress, messages: ShortfallMessages): GoalReport = GoalReport(
            goal = progress.sentence,
            met = progress.status == GoalStatus.MET,
            status = when (progress.status) {
                GoalStatus.PENDING -> GoalReportStatus.PENDING
                GoalStatus.MET -> GoalReportStatus.MET
                GoalStatus.FAILED -> GoalReportStatus.FAILED
            },
            progress = roundToThousandths(progress.progress),
            parts = progress.parts.map { of(it, messages) },
            shortfall = progress.shortfall?.let { ReportedShortfall.of(it, messages) },
        )
    }
}

/** [GoalStatus] in a report. */
@Serializable
enum class GoalReportStatus {
    @SerialName("pending")
    PENDING,

    @SerialName("met")
    MET,

    @SerialName("failed")
    FAILED,
}

/** The result of the session so far. */
fun Session.report(): RunReport {
    val now = state
    val run = now.brick.run
    val shown = now.brick.leftByProgram ?: now.brick.screen
    return RunReport(
        status = statusOf(run),
        seconds = roundToThousandths(now.milliseconds / MILLISECONDS_PER_SECOND),
        pose = with(now.robot.pose) {
            ReportedPose(roundToThousandths(x), roundToThousandths(y), roundToThousandths(heading))
        },
        inkCentimetres = roundToThousandths(now.ink.lengthCentimetres),
        bumps = now.bumps,
        lcd = shown.text,
        romCalls = now.romCalls,
        traceHash = traceHash,
        error = (run as? RunState.Failed)?.failure?.let {
            listOfNotNull(it.place(PlaceMessages.of(language)), it.message).joinToString(": ")
        },
        goals = now.goals.map { GoalReport.of(it, SimulationMessages.of(language)) },
        missingSensors = now.missingSensors?.sensors.orEmpty().map {
            ReportedSensor(it.port, reported(it.kind), it.warning.message)
        },
        screen = if (now.brick.kind.displayRows > 1) shown.lines else emptyList(),
    )
}

private fun reported(kind: SensorKind): ReportedSensorKind = when (kind) {
    SensorKind.TOUCH -> ReportedSensorKind.TOUCH
    SensorKind.TEMPERATURE -> ReportedSensorKind.TEMPERATURE
    SensorKind.LIGHT -> ReportedSensorKind.LIGHT
    SensorKind.ROTATION -> ReportedSensorKind.ROTATION
    SensorKind.ULTRASONIC -> ReportedSensorKind.ULTRASONIC
    SensorKind.SOUND -> ReportedSensorKind.SOUND
    SensorKind.COLOUR -> ReportedSensorKind.COLOUR
    SensorKind.COMPASS -> ReportedSensorKind.COMPASS
    SensorKind.GYRO -> ReportedSensorKind.GYRO
    SensorKind.HITECHNIC_COLOUR -> ReportedSensorKind.HITECHNIC_COLOUR
    SensorKind.MINDSENSORS_COMPASS -> ReportedSensorKind.MINDSENSORS_COMPASS
    SensorKind.HITECHNIC_ACCELERATION -> ReportedSensorKind.HITECHNIC_ACCELERATION
    SensorKind.MINDSENSORS_ACCELERATION -> ReportedSensorKind.MINDSENSORS_ACCELERATION
    SensorKind.RCX_LIGHT -> ReportedSensorKind.RCX_LIGHT
    SensorKind.RCX_LINK -> ReportedSensorKind.RCX_LINK
    SensorKind.OPTICAL_DISTANCE -> ReportedSensorKind.OPTICAL_DISTANCE
    SensorKind.NXT_TEMPERATURE -> ReportedSensorKind.NXT_TEMPERATURE
    SensorKind.INFRARED_SEEKER -> ReportedSensorKind.INFRARED_SEEKER
    SensorKind.INFRARED_SEEKER_2 -> ReportedSensorKind.INFRARED_SEEKER_2
}

private fun statusOf(run: RunState): RunStatus = when (run) {
    RunState.Idle, is RunState.Ended -> RunStatus.ENDED
    is RunState.Running -> RunStatus.RUNNING
    is RunState.Failed -> RunStatus.FAILED
}

private const val MILLISECONDS_PER_SECOND = 1000.0
private val reportJson = Json { prettyPrint = true }
