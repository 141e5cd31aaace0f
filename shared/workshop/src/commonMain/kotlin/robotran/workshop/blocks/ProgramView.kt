package robotran.workshop.blocks

/** How a program is shown, which is a part of its project. */
typealias ProgramView = robotran.projects.ProgramView
