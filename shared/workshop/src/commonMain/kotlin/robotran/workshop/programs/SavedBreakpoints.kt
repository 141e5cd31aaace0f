package robotran.workshop.programs

import robotran.documents.SavedBreakpoint

/** The breakpoints of this program of the robot [robot], in order. */
internal fun ProgramBuffer.savedBreakpoints(robot: String): List<SavedBreakpoint> =
    program.files.zip(editorStates).flatMap { (file, editorState) ->
        editorState.breakpoints.sorted().map { SavedBreakpoint(robot, program.name, file.name, it) }
    }

/** This program with those of [breakpoints] whose lines it has. */
internal fun ProgramBuffer.withBreakpoints(breakpoints: List<SavedBreakpoint>): ProgramBuffer =
    program.files.foldIndexed(this) { index, buffer, file ->
        val editorState = buffer.editorStates[index]
        val lines = breakpoints.filter { it.file == file.name && it.line <= editorState.draft.lines.count }
        buffer.with(index, editorState.copy(breakpoints = lines.mapTo(mutableSetOf()) { it.line }))
    }
