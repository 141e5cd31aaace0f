package robotran.legofirmware.messages

import robotran.language.Language
import robotran.language.choose

/** All messages about programs of LEGO's firmware to a learner. Each language is an implementation. */
interface FirmwareMessages {
    val image: ImageMessages
    val assembly: AssemblyMessages
    val run: RunMessages

    companion object {
        fun of(language: Language): FirmwareMessages = language.choose(English, Spanish, German)
    }
}
