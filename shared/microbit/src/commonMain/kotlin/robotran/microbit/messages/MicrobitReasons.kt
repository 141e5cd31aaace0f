package robotran.microbit.messages

import robotran.microbit.program.MicrobitError

/** Why a program ends whose call the board refuses, in a sentence. */
fun MicrobitErrorMessages.reason(error: MicrobitError): String = when (error) {
    MicrobitError.NO_DEVICE -> noBuggy()
    MicrobitError.INVALID_ARGUMENT -> refusedNumber()
    MicrobitError.NO_SUCH_PART -> refusedPart()
}
