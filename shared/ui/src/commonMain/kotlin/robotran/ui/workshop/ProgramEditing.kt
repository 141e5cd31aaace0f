package robotran.ui.workshop

import robotran.rom.Brick

/** What a person does with the programs and which of them are shown. */
internal class ProgramEditing(
    private val shelf: ProgramShelf,
    private val state: () -> ProgramsState,
    private val show: (ProgramsState) -> Unit,
    private val bringToFront: () -> Unit,
) {
    fun handle(event: ProgramEvent) {
        when (event) {
            is ProgramEvent.ProgramEdited -> edit(state().shownFile, event.text)
            is ProgramEvent.FixApplied -> applyFix(event)
            is ProgramEvent.ProgramChosen -> if (event.slot in shelf.programs.indices) choose(event.slot)
            is ProgramEvent.FileChosen -> if (event.place in state().program.files.indices) show(state().copy(shownFile = event.place))
            is ProgramEvent.ProgramAdded -> add(shelf.programs.size, event.program.withPlainLineEnds())
            is ProgramEvent.ProgramBegun -> add(shelf.programs.size, newProgram(event.language, shelf.programs))
            ProgramEvent.ClassAdded -> addClass()
            is ProgramEvent.ProgramClosed -> close(event.slot)
            ProgramEvent.ProgramReopened -> reopen()
        }
    }

    /** Shows what is wrong with the program in [slot]. */
    fun pointOutMistakes(slot: Int) {
        if (slot != state().shownProgram) choose(slot)
        val place = state().program.files.indexOfFirst { it.name == shelf.mistakes(slot).firstOrNull()?.file }
        show(state().copy(mistakePointedOut = true, shownFile = if (place >= 0) place else state().shownFile))
        bringToFront()
    }

    private fun edit(file: Int, written: String) {
        val text = written.withPlainLineEnds()
        val now = state()
        if (text == now.program.files[file].text) return
        shelf.change(now.shownProgram, now.program.withText(file, text))
        refresh(now.copy(mistakePointedOut = false))
    }

    private fun applyFix(event: ProgramEvent.FixApplied) {
        val fix = event.mistake.fix ?: return
        if (event.mistake !in shelf.mistakes(state().shownProgram)) return
        val file = state().program.files.indexOfFirst { it.name == event.mistake.file }
        if (file < 0) return
        edit(file, state().program.files[file].text.mendedBy(fix))
        refresh(state().copy(shownFile = file))
    }

    private fun choose(slot: Int) = refresh(state().copy(shownProgram = slot, shownFile = 0, mistakePointedOut = false))

    private fun add(slot: Int, program: PupilProgram) {
        if (shelf.programs.size >= Brick.MOST_PROGRAMS) return
        shelf.insert(slot, program)
        refresh(state().copy(programs = shelf.programs, shownProgram = slot, shownFile = 0, mistakePointedOut = false))
        bringToFront()
    }

    private fun addClass() {
        val now = state()
        if (now.program.language != ProgramLanguage.JAVA) return
        val program = now.program.copy(files = now.program.files + newClass(now.program))
        shelf.change(now.shownProgram, program)
        refresh(now.copy(shownFile = program.files.lastIndex))
    }

    private fun close(slot: Int) {
        if (slot !in shelf.programs.indices || shelf.programs.size == 1) return
        val closed = shelf.programs[slot]
        shelf.remove(slot)
        val shown = state().shownProgram.let { if (it > slot || it > shelf.programs.lastIndex) it - 1 else it }
        refresh(state().copy(closedProgram = closed, shownProgram = shown, shownFile = 0, mistakePointedOut = false))
    }

    private fun reopen() {
        val program = state().closedProgram ?: return
        if (shelf.programs.size >= Brick.MOST_PROGRAMS) return
        show(state().copy(closedProgram = null))
        add(shelf.programs.size, program)
    }

    private fun refresh(now: ProgramsState) = show(now.copy(programs = shelf.programs, mistakes = shelf.mistakes(now.shownProgram)))
}

internal fun PupilProgram.withPlainLineEnds(): PupilProgram = copy(files = files.map { it.copy(text = it.text.withPlainLineEnds()) })
