package robotran.assignments.doing

import robotran.documents.FileStamp
import robotran.projects.Project
import robotran.projects.writeCompactHandIn

/**
 * [project], which has been handed in, with the hash of everything else in it. The hash guards against accidents; it is
 * not a signature. It leaves out the world unless the assignment allows to change that, as a link to the hand-in does.
 */
fun sealedHandIn(project: Project): Project {
    val handIn = requireNotNull(project.handIn) { "The project was not handed in." }
    return project.copy(handIn = handIn.copy(hash = hashOf(project)))
}

/** Whether [project] is as [sealedHandIn] left it; false if it was not handed in. */
fun isIntact(project: Project): Boolean = project.handIn?.hash == hashOf(project)

/** As saved, so that a project that was read back has the same hash. */
private fun hashOf(project: Project): String {
    val plain = project.copy(handIn = project.handIn?.copy(hash = ""))
    return FileStamp.of(writeCompactHandIn(plain).encodeToByteArray()).text
}
