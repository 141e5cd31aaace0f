package robotran.lejoslinker.link

import robotran.lejoslinker.config.ImageLimits
import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.classMissing
import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.classfile.ClassFile
import robotran.tinyvm.classfile.Constant
import robotran.tinyvm.classfile.DamagedClassFile
import robotran.tinyvm.classfile.MemberKind
import robotran.tinyvm.link.SpecialNumbers

/**
 * Finds the classes of an image and numbers them: the special ones first, then those that can be started, then what each
 * names in its constants, in this order. Source: leJOS `Binary.java`.
 */
internal class ClassCollector(
    private val files: ClassFiles,
    private val errors: ErrorList,
    private val messages: ImageMessages,
) {
    private val names = LinkedHashSet<String>()
    private val found = ArrayList<ClassFile>()
    private val notFound = LinkedHashMap<String, CodePlace>()

    /**
     * The internal names of classes that are not there, with the first class that names each. Whether code uses them shows
     * later; a compiler may name a class only in an attribute.
     */
    val missing: Map<String, CodePlace> get() = notFound

    /**
     * Returns the classes by number, only those of [used] if there is that. It is complete only if there are no errors and
     * nothing is [missing].
     */
    fun collect(entryClasses: List<String>, used: UsedParts?): List<ImageClass> {
        for (special in SpecialNumbers.CLASSES) {
            val place = CodePlace(special)
            add(special, place)
            if (special in notFound) errors.add(place, messages.classMissing(special))
        }
        for (entry in entryClasses) {
            if (files.isOwn(entry)) {
                add(entry, CodePlace(entry))
            } else {
                errors.add(CodePlace(entry), messages.tinyVm.noMainMethod())
            }
        }
        var next = 0
        if (used == null) {
            while (next < found.size) addNamedIn(found[next++])
        } else {
            used.classes.forEach { add(it, CodePlace(entryClasses.first())) }
        }
        if (found.size > ImageLimits.CLASSES) {
            errors.add(CodePlace(entryClasses.first()), messages.tooManyClasses(found.size, ImageLimits.CLASSES))
        }
        return found.mapIndexed { number, file ->
            ImageClass(number, file, files.isOwn(file.name), file.name in entryClasses)
        }
    }

    private fun addNamedIn(file: ClassFile) {
        val place = CodePlace(file.name)
        val constants = file.constants
        try {
            for (constant in constants.all) {
                val name = when {
                    constant is Constant.ClassName -> constants.text(constant.textIndex)

                    constant is Constant.Member && constant.kind == MemberKind.METHOD -> {
                        constants.className(constant.classIndex)
                    }

                    else -> continue
                }
                if (!name.startsWith("[")) add(name, place)
            }
        } catch (_: DamagedClassFile) {
            errors.add(place, messages.tinyVm.classFileDamaged())
        }
    }

    private fun add(name: String, place: CodePlace) {
        if (!names.add(name)) return
        val file = files.find(name)
        if (file == null) notFound[name] = place else found += file
    }
}
