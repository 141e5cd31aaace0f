package robotran.legofirmware.messages

import robotran.language.quoted

internal object AssemblyEnglish : AssemblyMessages {
    override fun sourceTooLong(limit: Int) = "This text is too long. At most $limit characters are allowed."

    override fun unknownCharacter(text: String) = "The character ${quoted(text)} has no meaning here."

    override fun unknownCommand(word: String, suggestion: String?) =
        "There is no command ${quoted(word)}." + suggestion?.let { " Did you mean ${quoted(it)}?" }.orEmpty()

    override fun missingCommand(text: String) = "A line begins with a command or a label, not with ${quoted(text)}."

    override fun wrongNumberCount(form: String) = "The numbers do not fit the command. Its form is ${quoted(form)}."

    override fun missingComma(text: String) = "A comma is missing before ${quoted(text)}."

    override fun numberNeeded(text: String, name: String, form: String) = if (text.isEmpty()) {
        "The $name is missing. The form is ${quoted(form)}."
    } else {
        "${quoted(text)} is no number. The form is ${quoted(form)}."
    }

    override fun numberOutOfRange(name: String, number: Int, least: Int, greatest: Int) =
        "The $name is $number, but it must be from $least to $greatest."

    override fun labelNeeded(text: String, form: String) = if (text.isEmpty()) {
        "The label is missing. The form is ${quoted(form)}."
    } else {
        "${quoted(text)} is no label. The form is ${quoted(form)}."
    }

    override fun unknownLabel(name: String, suggestion: String?) =
        "There is no label ${quoted(name)}." + suggestion?.let { " Did you mean ${quoted(it)}?" }.orEmpty()

    override fun labelElsewhere(name: String) =
        "The label ${quoted(name)} is in another task or subroutine. A jump stays in its own."

    override fun labelTwice(name: String, firstLine: Int) = "The label ${quoted(name)} is already on line $firstLine."

    override fun tooFar(command: String, target: String, longForm: String?) =
        "${quoted(command)} does not reach ${quoted(target)}." +
            longForm?.let { " Use ${quoted(it)}, which reaches further and also backwards." }.orEmpty()

    override fun outsideChunk(text: String) =
        "${quoted(text)} is outside a task. Begin with ${quoted("task 0")} and end with ${quoted("endt")}."

    override fun notClosed(frame: String, end: String) = "This ${quoted(frame)} has no ${quoted(end)}."

    override fun wrongEnd(word: String, expected: String?) = if (expected == null) {
        "${quoted(word)} closes nothing: no task or subroutine is open."
    } else {
        "${quoted(word)} is wrong here. ${quoted(expected)} closes what is open."
    }

    override fun chunkTwice(frame: String, number: Int) = "There is already a ${quoted("$frame $number")}."

    override fun codeTooLong(limit: Int) = "This task or subroutine is too long. At most $limit bytes are allowed."

    override fun newerCommand(command: String) =
        "Only firmware 2.0 knows ${quoted(command)}. The program is for firmware 1.0."

    override fun newerSource(source: Int) = "Only firmware 2.0 knows source $source. The program is for firmware 1.0."

    override fun newerVariable(variable: Int) = "There is no variable $variable in firmware 1.0. The last one is 31."

    override fun restrictedSource(command: String, source: Int) =
        "In firmware 1.0, ${quoted(command)} does not take source $source. Put the value into a variable first."

    override fun unknownSource(source: Int) = "An RCX has no source $source. Its value is always 0."

    override fun requestOnly(command: String) =
        "${quoted(command)} works only over infrared light. In a program it does nothing."

    override fun noMainTask() = "There is no task 0, so the Run button starts nothing."
}
