package robotran.microbit.messages

import robotran.language.quoted
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitNative

/** What [call] did, in words; [meaning] is what a call to a chip or a pin has come to. */
internal fun MicrobitMessages.describe(call: MicrobitCall, meaning: MicrobitMeaning): String {
    val n = call.numbers
    val text = quoted(call.text.orEmpty())
    return when (call.native) {
        MicrobitNative.I2C_WRITE -> moved(meaning) ?: chipReady()
        MicrobitNative.PIN_ANALOG, MicrobitNative.PIN_DIGITAL -> moved(meaning) ?: pinSet(n[0], n[1])
        MicrobitNative.PIN_PERIOD -> pinReady(n[0])
        MicrobitNative.DISPLAY_SHOW -> show(text)
        MicrobitNative.DISPLAY_SCROLL -> scroll(text)
        MicrobitNative.DISPLAY_CLEAR -> clear()
        MicrobitNative.MUSIC_PITCH -> tone(n[0], n[1])
        MicrobitNative.MUSIC_STOP -> silence()
        MicrobitNative.PRINT -> printed(text)
    }
}

private fun MicrobitMessages.moved(meaning: MicrobitMeaning): String? = when (meaning) {
    MicrobitMeaning.SetUp -> null
    is MicrobitMeaning.Servo -> servo(meaning.degrees)

    is MicrobitMeaning.Wheels ->
        if (meaning.left == 0 && meaning.right == 0) wheelsStopped() else wheels(meaning.left, meaning.right)
}
