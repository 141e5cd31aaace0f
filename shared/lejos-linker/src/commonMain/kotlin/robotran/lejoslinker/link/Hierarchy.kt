package robotran.lejoslinker.link

import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.classMissing
import robotran.lejoslinker.messages.tinyVm

/** The relations between the classes of an image. */
internal class Hierarchy(private val classes: List<ImageClass>) {
    private val byName = classes.associateBy { it.name }

    fun classNamed(name: String): ImageClass? = byName[name]

    /** Sets the superclass of each class, and refuses classes whose superclass is missing or that are above themselves. */
    fun connect(errors: ErrorList, messages: ImageMessages) {
        val root = classes.first()
        for (each in classes.drop(1)) {
            each.superclass = each.file.superName?.let { byName[it] }
            if (each.superclass != null) continue
            val name = each.file.superName
            val message = if (name == null) messages.tinyVm.codeInvalid() else messages.classMissing(name)
            errors.add(CodePlace(each.name), message)
        }
        for (each in classes) {
            if (generateSequence(each) { it.superclass }.take(classes.size + 1).last() !== root && errors.isEmpty) {
                errors.add(CodePlace(each.name), messages.tinyVm.cyclicInheritance(each.name.replace('/', '.')))
            }
        }
    }

    /** The method with this [signature] that a call of class [owner] means; null if there is none. */
    fun method(owner: String, signature: String): ImageMethod? {
        val first = classOrRoot(owner) ?: return null
        return ancestors(first).firstNotNullOfOrNull { it.methodNamed(signature) }
            ?: interfaces(first).firstNotNullOfOrNull { it.methodNamed(signature) }
    }

    /** The field that an access through class [owner] means; null if there is none. */
    fun field(owner: String, name: String, descriptor: String, isStatic: Boolean): ImageField? {
        val first = byName[owner] ?: return null
        return (ancestors(first) + interfaces(first)).firstNotNullOfOrNull { each ->
            val fields = if (isStatic) each.staticFields else each.instanceFields
            fields.find { it.name == name && it.descriptor == descriptor }
        }
    }

    /** Arrays have the methods of Object. */
    private fun classOrRoot(name: String) = if (name.startsWith("[")) classes.first() else byName[name]

    private fun ancestors(first: ImageClass) = generateSequence(first) { it.superclass }

    /** All interfaces above [first], nearest first. */
    private fun interfaces(first: ImageClass): Sequence<ImageClass> = sequence {
        val waiting = ArrayDeque(ancestors(first).flatMap { it.file.interfaces }.toList())
        val seen = HashSet<String>()
        while (waiting.isNotEmpty()) {
            val name = waiting.removeFirst()
            val each = byName[name] ?: continue
            if (!seen.add(name)) continue
            yield(each)
            waiting += each.file.interfaces
        }
    }
}
