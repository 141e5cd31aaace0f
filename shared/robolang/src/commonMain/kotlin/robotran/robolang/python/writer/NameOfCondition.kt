package robotran.robolang.python.writer

import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.withParts

/** A name for what [condition] asks for: that of its first sense; null if it has none. */
internal fun nameOfCondition(condition: Expression): String? =
    when (val sense = withParts(condition).filterIsInstance<Expression.Sense>().firstOrNull()?.sense) {
        Sense.LeftBumper -> "left_bumper"
        Sense.RightBumper -> "right_bumper"
        Sense.Light -> "light"
        Sense.Timer -> "timer"
        Sense.Battery -> "battery"
        Sense.Distance -> "distance"
        Sense.Loudness -> "loudness"
        Sense.Colour -> "colour"
        is Sense.Button -> "button_${sense.button.keyword.text}"
        is Sense.Sensor -> "sensor_${sense.port}"
        is Sense.Turned -> "turned_${sense.port.name.lowercase()}"
        null -> null
    }
