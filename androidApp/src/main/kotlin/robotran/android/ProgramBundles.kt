package robotran.android

import android.os.Bundle
import androidx.core.os.bundleOf
import robotran.ui.workshop.ProgramFile
import robotran.ui.workshop.PupilProgram

/** [programs] as Android keeps them, if they are not too long for it. */
internal fun bundlesOf(programs: List<PupilProgram>): ArrayList<Bundle> {
    val characters = programs.sumOf { program -> program.files.sumOf { it.text.length } }
    return ArrayList(if (characters > MOST_CHARACTERS) emptyList() else programs.map(::bundleOf))
}

/** The program in [bundle], which [bundlesOf] has made. */
internal fun programOf(bundle: Bundle): PupilProgram {
    val names = bundle.getStringArray(NAMES).orEmpty()
    val texts = bundle.getStringArray(TEXTS).orEmpty()
    return PupilProgram(names.zip(texts) { name, text -> ProgramFile(name, text) })
}

private fun bundleOf(program: PupilProgram): Bundle =
    bundleOf(NAMES to program.files.map { it.name }.toTypedArray(), TEXTS to program.files.map { it.text }.toTypedArray())

private const val NAMES = "names"
private const val TEXTS = "texts"

/** Android ends an app whose saved state is larger than about a megabyte; a character takes two bytes. */
private const val MOST_CHARACTERS = 100_000
