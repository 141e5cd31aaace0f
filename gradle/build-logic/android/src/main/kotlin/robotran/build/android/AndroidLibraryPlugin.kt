package robotran.build.android

import com.android.build.api.dsl.LibraryExtension
import org.gradle.api.Plugin
import org.gradle.api.Project

/** An Android library. Its namespace is `robotran` and the name of its module. */
class AndroidLibraryPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("com.android.library")
        project.pluginManager.apply(AndroidPlugin::class.java)
        val name = project.name.replace('-', '.') // a namespace is a package
        project.extensions.configure(LibraryExtension::class.java) { it.namespace = "robotran.$name" }
    }
}
