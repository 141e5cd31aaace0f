package robotran.legofirmware.device

/** What the display shows: chosen with the View button or by a program. */
internal class Viewing {
    /** 0 the watch, 1..3 a sensor, 4..6 a motor, 7 the value of a program. */
    var number = 0
        private set

    /** Decimals of the value of a program, 0..3. */
    var decimals = 0
        private set

    /** Source and argument of the value of a program, read again at each refresh; null if there is none. */
    var value: Pair<Int, Int>? = null
        private set

    /** Ignored if there is no such thing to show. */
    fun show(number: Int, hasUserValue: Boolean) {
        if (number in 0..LAST_PORT || (number == USER && hasUserValue)) this.number = number
    }

    /** What the View button does: the next of watch, sensors, motors. */
    fun showNext() {
        number = if (number >= LAST_PORT) 0 else number + 1
    }

    fun setUserValue(decimals: Int, source: Int, argument: Int) {
        this.decimals = decimals.coerceIn(0, MOST_DECIMALS)
        value = source to argument
    }

    /** The program that has set the value is over. */
    fun forgetUserValue() {
        value = null
        if (number == USER) number = 0
    }

    companion object {
        const val FIRST_SENSOR = 1
        const val FIRST_MOTOR = 4
        const val LAST_PORT = 6
        const val USER = 7
        private const val MOST_DECIMALS = 3
    }
}
