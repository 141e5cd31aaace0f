package robotran.tinyvm.link

import robotran.tinyvm.classfile.endOfType
import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.LinkMessages

/** All classes and array types of a program, each linked on first use. */
internal class TypeTable(private val files: ClassPath, private val messages: LinkMessages, val model: MachineModel) {
    private val specialNumbers = if (model.isExact) NxtNumbers.CLASSES else SpecialNumbers.CLASS_NUMBERS
    private val byDescriptor = HashMap<String, HeapType>()
    private val beingLinked = LinkedHashSet<String>()
    private val allTypes = ArrayList<HeapType>()
    private val allClasses = ArrayList<LinkedClass>()
    private var arrayTypes = 0
    private var ordinaryClasses = 0

    /** The layout of fields and methods. */
    val members = MemberTable(messages, model)

    val types: List<HeapType> get() = allTypes

    val classes: List<LinkedClass> get() = allClasses

    val root: LinkedClass get() = classNamed(ROOT, CodeLocation(ROOT))

    val throwable: LinkedClass get() = classNamed("java/lang/Throwable", CodeLocation(ROOT))

    val text: LinkedClass get() = classNamed("java/lang/String", CodeLocation(ROOT))

    /** The heap type with this [descriptor]. */
    fun typeOf(descriptor: String, location: CodeLocation): HeapType =
        byDescriptor[descriptor] ?: when (descriptor[0]) {
            'L' -> classNamed(descriptor.substring(1, descriptor.length - 1), location)
            else -> arrayType(descriptor, location)
        }

    /** The type of a class constant: a class by its name, an array by its descriptor. */
    fun typeNamed(name: String, location: CodeLocation): HeapType = when {
        !name.startsWith("[") -> classNamed(name, location)
        endOfType(name, 0) == name.length -> typeOf(name, location)
        else -> location.unsound(messages)
    }

    /** The class with the internal name [name]. */
    fun classNamed(name: String, location: CodeLocation): LinkedClass =
        byDescriptor["L$name;"] as LinkedClass? ?: link(name, location)

    private fun arrayType(descriptor: String, location: CodeLocation): ArrayType {
        if (descriptor.takeWhile { it == '[' }.length > TinyVmLimits.ARRAY_DIMENSIONS) location.unsound(messages)
        val elementDescriptor = descriptor.drop(1)
        val element = if (isReferenceDescriptor(elementDescriptor)) typeOf(elementDescriptor, location) else null
        if (++arrayTypes > TinyVmLimits.ARRAY_TYPES) {
            location.reject(messages.tooMany(Counted.ARRAY_TYPES, TinyVmLimits.ARRAY_TYPES))
        }
        val root = root
        return ArrayType(allTypes.size, descriptor, element, root, model.isExact).also { add(it) }
    }

    private fun link(name: String, location: CodeLocation): LinkedClass {
        val file = files.find(name) ?: location.reject(messages.classMissing(name.replace('/', '.')))
        val own = CodeLocation(name)
        if (!beingLinked.add(name)) own.reject(messages.cyclicInheritance(name.replace('/', '.')))
        if (beingLinked.size > TinyVmLimits.ANCESTORS) {
            own.reject(messages.tooMany(Counted.ANCESTORS, TinyVmLimits.ANCESTORS))
        }
        if (file.superName == null && name != ROOT) own.unsound(messages)
        val superclass = file.superName?.let { classNamed(it, own) }
        val interfaces = file.interfaces.map { classNamed(it, own) }
        if (superclass?.isInterface == true || interfaces.any { !it.isInterface }) own.unsound(messages)
        val linked =
            LinkedClass(
                allTypes.size,
                allClasses.size,
                brickNumberOf(name),
                file,
                superclass,
                interfaces,
                files.isOwn(name),
                files.sourceFileOf(name),
            )
        if (linked.ancestorCount > TinyVmLimits.ANCESTORS) {
            own.reject(messages.tooMany(Counted.ANCESTORS, TinyVmLimits.ANCESTORS))
        }
        add(linked)
        allClasses += linked
        if (allClasses.size > TinyVmLimits.CLASSES) own.reject(messages.tooMany(Counted.CLASSES, TinyVmLimits.CLASSES))
        beingLinked -= name
        members.place(linked)
        return linked
    }

    private fun brickNumberOf(name: String): Int {
        return specialNumbers[name] ?: (specialNumbers.values.max() + 1 + ordinaryClasses++)
    }

    private fun add(type: HeapType) {
        byDescriptor[type.descriptor] = type
        allTypes += type
    }

    private companion object {
        const val ROOT = "java/lang/Object"
    }
}
