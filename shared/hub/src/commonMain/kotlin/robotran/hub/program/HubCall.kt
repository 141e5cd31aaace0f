package robotran.hub.program

import robotran.hub.model.HubButton
import robotran.hub.model.HubColor
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubPort

/**
 * A call by which a program acts on a hub. The numbers are those that the hub uses: whole, cut towards 0.
 *
 * @property numbers at least as many as the call has [parameters][HubNative.parameters]; must not change afterwards.
 * @property text what to show or print.
 */
class HubCall(val native: HubNative, val numbers: IntArray = NONE, val text: String? = null) {
    /** The port of a call that has one; null if there is no such port. */
    val port: HubPort? get() = numbers.firstOrNull()?.let(HubPort.entries::getOrNull)

    /** Passes what identifies the call to [add], in this order: id, numbers, text. */
    fun identify(add: (Long) -> Unit) {
        add(native.id.toLong())
        for (number in numbers) add(number.toLong())
        if (text != null) {
            add(text.length.toLong())
            add(text.fold(0) { hash, character -> HASH_FACTOR * hash + character.code }.toLong())
        }
    }

    /** The call as the log shows it, such as `motor A run_angle 500 360 nowait`. */
    override fun toString(): String = when (native) {
        HubNative.DEVICE -> "${native.words} ${nameOf(HubDeviceKind.entries, 1) { it.className }} $portName" +
            if (number(2) == 0) "" else " counterclockwise"

        HubNative.DRIVE_BASE_CREATE -> "${native.words} ${thousandths(number(2))} ${thousandths(number(THIRD))}"

        HubNative.MOTOR_RUN_ANGLE, HubNative.MOTOR_RUN_TARGET ->
            "motor $portName ${native.words} ${number(1)} ${number(2)}" + if (number(THIRD) == 0) "" else " nowait"

        HubNative.MOTOR_RUN, HubNative.MOTOR_RESET_ANGLE -> "motor $portName ${native.words} ${number(1)}"
        HubNative.MOTOR_BRAKE, HubNative.MOTOR_STOP, HubNative.MOTOR_HOLD -> "motor $portName ${native.words}"
        HubNative.LIGHT_ON -> "${native.words} ${nameOf(HubColor.entries, 0) { it.name }}"

        HubNative.SET_STOP_BUTTON ->
            "${native.words} ${HubButton.entries.getOrNull(number(0))?.name ?: "none"}"

        HubNative.DETECTABLE_COLORS ->
            "sensor $portName ${native.words} ${colors.joinToString(",") { it.name }}"

        else -> (listOf(native.words) + listOfNotNull(text?.let(::shown)) + numbers.map { "$it" }).joinToString(" ")
    }

    /** The colours of a call that has some. */
    internal val colors: List<HubColor> get() = numbers.drop(1).mapNotNull(HubColor.entries::getOrNull)

    private val portName: String get() = port?.name ?: "?"

    private fun number(place: Int): Int = numbers.getOrElse(place) { 0 }

    private fun <T> nameOf(entries: List<T>, place: Int, name: (T) -> String): String =
        entries.getOrNull(number(place))?.let(name) ?: "?"

    private fun shown(text: String) = "\"${text.replace("\n", "\\n")}\""

    companion object {
        private val NONE = IntArray(0)
        private const val HASH_FACTOR = 31
        private const val THIRD = 3
        private const val THOUSAND = 1_000
        private const val DECIMALS = 3

        /** A call with numbers only. */
        fun of(native: HubNative, vararg numbers: Int): HubCall = HubCall(native, numbers)

        /** A call about a port, with [numbers] behind it. */
        fun on(native: HubNative, port: HubPort, vararg numbers: Int): HubCall =
            HubCall(native, intArrayOf(port.ordinal, *numbers))

        /** A call with a text. */
        fun of(native: HubNative, text: String): HubCall = HubCall(native, text = text)

        /** See [HubNative.DEVICE]. */
        fun device(kind: HubDeviceKind, port: HubPort, isReversed: Boolean = false): HubCall =
            of(HubNative.DEVICE, port.ordinal, kind.ordinal, if (isReversed) 1 else 0)

        /** See [HubNative.DRIVE_BASE_CREATE]; lengths in thousandths of a millimetre. */
        fun driveBase(left: HubPort, right: HubPort, wheel: Int, track: Int): HubCall =
            of(HubNative.DRIVE_BASE_CREATE, left.ordinal, right.ordinal, wheel, track)

        /** See [HubNative.DETECTABLE_COLORS]. */
        fun detectableColors(port: HubPort, colors: List<HubColor>): HubCall =
            on(HubNative.DETECTABLE_COLORS, port, *IntArray(colors.size) { colors[it].ordinal })

        /** As written: `56`, `49.6`. */
        private fun thousandths(number: Int): String {
            val rest = (number % THOUSAND).toString().padStart(DECIMALS, '0').trimEnd('0')
            return "${number / THOUSAND}" + if (rest.isEmpty()) "" else ".$rest"
        }
    }
}
