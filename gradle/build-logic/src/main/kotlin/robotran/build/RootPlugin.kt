package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project

/** What the root project does: it holds no code, only the checks of the whole tree. */
class RootPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.group = "robotran"
    }
}
