package robotran.documents

import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject

/** [project] as the bytes of a `.robotran` file; null if there is more in it than any Robotran would read again. */
fun projectFile(project: Project): ByteArray? =
    writeProject(project).takeIf { readProject(it) is ProjectFileResult.Loaded }?.encodeToByteArray()

/** What is to be done about the file of a work before it is written. */
enum class SavingCheck {
    /** It is as the work left it, or not there any more: it can be written. */
    FREE,

    /** Somebody else has written something else into it meanwhile, which would be lost. */
    CHANGED_MEANWHILE,
}

/**
 * Whether [file] can be written without losing what somebody else has written.
 *
 * @param now what is in it now; null if it is not there.
 * @param toWrite what is to be written: if that is in it already, nothing is lost.
 */
fun checkBeforeSaving(file: SaveTarget, now: ByteArray?, toWrite: ByteArray): SavingCheck =
    if (now == null || FileStamp.of(now) == file.stamp ||
        now.contentEquals(toWrite)
    ) {
        SavingCheck.FREE
    } else {
        SavingCheck.CHANGED_MEANWHILE
    }
