package robotran.build.texts

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/** Gives a multiplatform module the `texts { }` block of [TextsExtension]. */
class TextsPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.extensions.create("texts", TextsExtension::class.java, project)
    }
}

/** Which text files of the tree a module has as Kotlin constants. */
open class TextsExtension(private val project: Project) {
    /**
     * Gives [sourceSet] a constant with the files of [folder], seen from the root of the tree, whose paths in it match [pattern].
     *
     * @param qualifiedName package and name of the constant, a `Map<String, String>` from path to content.
     */
    fun constant(sourceSet: String, qualifiedName: String, folder: String, pattern: String) {
        val name = qualifiedName.substringAfterLast('.')
        val task = project.tasks.register("generate" + name.replaceFirstChar(Char::uppercase), GenerateTexts::class.java) {
            it.texts.set(project.fileTree(project.rootProject.layout.projectDirectory.dir(folder)) { tree -> tree.include(pattern) })
            it.qualifiedName.set(qualifiedName)
            it.outputFolder.set(project.layout.buildDirectory.dir("generated/texts/$name"))
        }
        project.extensions.getByType(KotlinMultiplatformExtension::class.java).sourceSets.getByName(sourceSet).kotlin.srcDir(task)
    }
}
