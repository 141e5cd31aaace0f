package robotran.workshop.service

import robotran.projects.Assignment
import robotran.projects.AssignmentTries

/** Changes what the open project holds besides its world and its programs. */
interface AssignmentRepository {
    /** Keeps [assignment] in the project; null makes it a project like any other. */
    fun changeAssignment(assignment: Assignment?)

    /** Keeps [tries] in the project. */
    fun saveTries(tries: AssignmentTries?)
}
