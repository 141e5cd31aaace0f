package robotran.workshop.service

import robotran.projects.Project
import robotran.workshop.state.WorkToAdd

/** The pupil's stored projects as far as they are about assignments. */
interface StoredAssignments {
    /** The IDs of the newest projects in which a pupil works at the assignments [ids], by the IDs of these. */
    suspend fun worksAt(ids: Set<String>): Map<String, String>

    /** The stored project [id] as it is now, with the changes in the editor if it is open; null if it is missing. */
    suspend fun storedProject(id: String): Project?

    /** All stored projects that can be part of a course. */
    suspend fun assignmentsToAdd(): List<WorkToAdd>

    /** Opens the stored project [id]; tells the pupil why if that is impossible. */
    suspend fun openStored(id: String)
}
