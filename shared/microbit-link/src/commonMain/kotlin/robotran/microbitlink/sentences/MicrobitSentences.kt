package robotran.microbitlink.sentences

import robotran.language.Language
import robotran.microbitlink.BoardError
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.ImageError
import robotran.microbitlink.Remains
import robotran.microbitlink.messages.MicrobitTexts

/** What is wrong with a file, and what to do about it. */
fun ImageError.sentence(language: Language): String = when (this) {
    ImageError.NotHex -> MicrobitTexts.notHex(language)
    is ImageError.Damaged -> MicrobitTexts.damaged(language, line)
    ImageError.Incomplete -> MicrobitTexts.incomplete(language)
    ImageError.NoMicroPython -> MicrobitTexts.noMicroPython(language)
    is ImageError.OtherBoard -> MicrobitTexts.otherBoard(language, wanted?.name)
    ImageError.TooOld -> MicrobitTexts.tooOld(language)
    ImageError.BrokenFiles -> MicrobitTexts.brokenFiles(language)
    is ImageError.TooLarge -> MicrobitTexts.tooLarge(language, bytes, maxBytes)
    is ImageError.EmptyFile -> MicrobitTexts.emptyFile(language, name)
    is ImageError.BadName -> MicrobitTexts.badName(language, name)
}

/** What is wrong with the board or the way to it, and what to do about it. */
fun BoardError.sentence(language: Language): String = when (this) {
    BoardError.OutOfReach -> MicrobitTexts.outOfReach(language)
    BoardError.Taken -> MicrobitTexts.taken(language)
    BoardError.NotAllowed -> MicrobitTexts.notAllowed(language)
    BoardError.InterfaceTooOld -> MicrobitTexts.interfaceTooOld(language)
    BoardError.NotAMicrobit -> MicrobitTexts.notAMicrobit(language)
    is BoardError.BadFile -> error.sentence(language)
    BoardError.BrokenOff -> MicrobitTexts.brokenOff(language)
    BoardError.BadConnection -> MicrobitTexts.badConnection(language)
    is BoardError.Refused -> MicrobitTexts.refused(language, kind.sentence(language), number)
    BoardError.NoPython -> MicrobitTexts.noPython(language)
    BoardError.NoRoom -> MicrobitTexts.noRoom(language)
    BoardError.NotAsSent -> MicrobitTexts.notAsSent(language)
}

/** What an error number means, and what to do about it: for one that somebody has read off the board. */
fun FlashErrorKind.sentence(language: Language): String = MicrobitTexts.flashError(language, this)

/** What the board has now. */
fun Remains.sentence(language: Language): String = MicrobitTexts.remains(language, this)
