package robotran.robolang.syntax

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceRange
import robotran.robolang.words.BrickFeature
import robotran.robolang.words.Keyword

/** A line of the header. */
internal sealed interface RobotSetting {
    val range: SourceRange

    /**
     * Whether a header cannot have both this line and [other].
     *
     * @param severalOfAKind whether there can be sensors of the same kind on different ports.
     */
    fun excludes(other: RobotSetting, severalOfAKind: Boolean): Boolean
}

/** `brick nxt`. */
internal data class BrickSetting(override val range: SourceRange, val kind: BrickKind) : RobotSetting {
    override fun excludes(other: RobotSetting, severalOfAKind: Boolean): Boolean = other is BrickSetting
}

/**
 * `light sensor on 2 facing down`.
 *
 * @property port 1..4, as it is printed on the brick.
 */
internal data class LightSensorSetting(override val range: SourceRange, val port: Int, val facing: Facing) :
    RobotSetting {
    override fun excludes(other: RobotSetting, severalOfAKind: Boolean): Boolean =
        other is LightSensorSetting && (!severalOfAKind || other.port == port)
}

/**
 * `sonar on 4`, `colour sensor on 3` and `sound sensor on 2`.
 *
 * @property port 1..4, as it is printed on the brick.
 */
internal data class SensorSetting(override val range: SourceRange, val sensor: NxtSensor, val port: Int) :
    RobotSetting {
    override fun excludes(other: RobotSetting, severalOfAKind: Boolean): Boolean =
        other is SensorSetting && other.sensor == sensor && (!severalOfAKind || other.port == port)
}

internal enum class Facing { DOWN, FORWARD }

/**
 * The sensors that only an NXT has.
 *
 * @property words the words of its setting before `on`.
 * @property port its port unless the header names another.
 */
internal enum class NxtSensor(val words: List<Keyword>, val port: Int, val feature: BrickFeature) {
    SONAR(listOf(Keyword.SONAR), 4, BrickFeature.SONAR),
    COLOUR(listOf(Keyword.COLOUR, Keyword.SENSOR), 3, BrickFeature.COLOUR_SENSOR),
    SOUND(listOf(Keyword.SOUND, Keyword.SENSOR), 2, BrickFeature.SOUND_SENSOR),
    ;

    /** Its setting on [port]. */
    fun settingOn(port: Int): String = words.joinToString(" ") { it.text } + " on $port"
}
