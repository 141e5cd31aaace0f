package robotran.legofirmware.assembly

import robotran.language.Language
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.OpcodeUse
import robotran.legofirmware.messages.CommandHelpMessages

/**
 * What a command of assembly text does.
 *
 * @property forms how it is written, such as `wait source, argument`.
 * @property sentence one sentence in a pupil's words.
 */
data class CommandHelp(val mnemonic: String, val forms: List<String>, val sentence: String) {
    companion object {
        /** The mnemonics of all commands that a program may have, each once. */
        val mnemonics: List<String> = Opcode.entries.filter {
            it.use != OpcodeUse.REQUEST
        }.map { it.mnemonic }.distinct()

        /** The help in [language] on the command [word]; null if there is no such command in programs. */
        fun of(word: String, language: Language): CommandHelp? {
            val mnemonic = word.lowercase()
            val sentence = CommandHelpMessages.of(language).sentence(mnemonic).ifEmpty { return null }
            val forms = Opcode.named(mnemonic).filter { it.use != OpcodeUse.REQUEST }.map { CommandForm(it).toString() }
            return CommandHelp(mnemonic, forms, sentence)
        }
    }
}
