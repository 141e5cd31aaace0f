package robotran.hublink.sentences

import robotran.hublink.HubError
import robotran.hublink.Remains
import robotran.hublink.UnseenCause
import robotran.hublink.messages.HubTexts
import robotran.hublink.output.ProgramError
import robotran.hublink.output.ProgramErrorKind
import robotran.language.Language

/** What is wrong and what to do about it. Of a hub that is not seen, the causes follow, a line for each. */
fun HubError.sentence(language: Language): String = when (this) {
    is HubError.NotSeen -> (
        listOf(HubTexts.notSeen(language)) + causes.map {
            it.sentence(language)
        }
    ).joinToString("\n")
    HubError.OutOfReach -> HubTexts.outOfReach(language)
    HubError.Taken -> HubTexts.taken(language)
    HubError.NotAllowed -> HubTexts.notAllowed(language)
    HubError.BluetoothNotAllowed -> HubTexts.bluetoothNotAllowed(language)
    HubError.LegoFirmware -> HubTexts.legoFirmware(language)
    is HubError.TooOld -> HubTexts.tooOld(language, firmware?.toString())
    is HubError.TooLarge -> HubTexts.tooLarge(language, bytes, maxBytes)
    is HubError.NumberTooLarge -> HubTexts.numberTooLarge(language, number)
    HubError.NotAProgram -> HubTexts.notAProgram(language)
    HubError.Busy -> HubTexts.busy(language)
    HubError.DoesNotStop -> HubTexts.doesNotStop(language)
    HubError.NoProgram -> HubTexts.noProgram(language)
    HubError.BrokenOff -> HubTexts.brokenOff(language)
    HubError.BadConnection -> HubTexts.badConnection(language)
    is HubError.Refused -> HubTexts.refused(language, code)
}

/** What the hub has now. */
fun Remains.sentence(language: Language): String = HubTexts.remains(language, this)

/** What to look at. */
fun UnseenCause.sentence(language: Language): String = when (this) {
    UnseenCause.OFF -> HubTexts.causeOff(language)
    UnseenCause.PROGRAM_RUNS -> HubTexts.causeProgramRuns(language)
    UnseenCause.TOO_FAR -> HubTexts.causeTooFar(language)
    UnseenCause.TAKEN -> HubTexts.causeTaken(language)
    UnseenCause.LEGO_FIRMWARE -> HubTexts.causeLegoFirmware(language)
    UnseenCause.BLUETOOTH_OFF -> HubTexts.causeBluetoothOff(language)
}

/** Why the program has ended. Its line is told beside it. */
fun ProgramError.sentence(language: Language): String = when (kind) {
    ProgramErrorKind.MISSING_DEVICE -> HubTexts.missingDevice(language, port)
    ProgramErrorKind.NUMBER_TOO_LARGE -> HubTexts.overflow(language)
    ProgramErrorKind.DIVISION_BY_ZERO -> HubTexts.divisionByZero(language)
    ProgramErrorKind.OUTSIDE_LIST -> HubTexts.outsideList(language)
    ProgramErrorKind.NO_MEMORY -> HubTexts.noMemory(language)
    ProgramErrorKind.OTHER -> HubTexts.otherError(language, python)
}
