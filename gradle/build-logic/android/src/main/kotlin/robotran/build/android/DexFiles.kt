package robotran.build.android

import org.jf.dexlib2.Opcodes
import org.jf.dexlib2.dexbacked.DexBackedClassDef
import org.jf.dexlib2.dexbacked.DexBackedDexFile
import org.jf.dexlib2.iface.instruction.ReferenceInstruction
import org.jf.dexlib2.iface.reference.FieldReference
import org.jf.dexlib2.iface.reference.MethodReference
import org.jf.dexlib2.iface.reference.TypeReference
import java.io.File
import java.util.zip.ZipFile

/** Adds all classes of the dex files in [apk], and the references in their code. */
internal fun UsedApi.declareAndReadDex(apk: File) = ZipFile(apk).use { zip ->
    val dexFiles = zip.entries().asSequence().filter { it.name.endsWith(".dex") }.toList()
    for (entry in dexFiles) {
        val bytes = zip.getInputStream(entry).use { it.readBytes() }
        DexBackedDexFile(Opcodes.getDefault(), bytes).classes.forEach(::declareAndRead)
    }
}

private fun UsedApi.declareAndRead(definition: DexBackedClassDef) {
    val name = nameOf(definition.type)
    val supertypes = (listOfNotNull(definition.superclass) + definition.interfaces).map(::nameOf)
    val members = definition.fields.map { it.name } + definition.methods.map(::nameOf)
    declare(name, supertypes, members.toSet())
    supertypes.forEach { use(it, null, name) }
    for (method in definition.methods) {
        for (instruction in method.implementation?.instructions ?: emptyList()) {
            if (instruction is ReferenceInstruction) use(instruction, "$name.${nameOf(method)}")
        }
    }
}

private fun UsedApi.use(instruction: ReferenceInstruction, from: String) {
    when (val reference = instruction.reference) {
        is MethodReference -> use(nameOf(reference.definingClass), nameOf(reference), from)
        is FieldReference -> use(nameOf(reference.definingClass), reference.name, from)
        is TypeReference -> if (reference.type.startsWith('L')) use(nameOf(reference.type), null, from)
    }
}

private fun nameOf(type: String) = type.removePrefix("L").removeSuffix(";")

private fun nameOf(method: MethodReference) =
    method.name + method.parameterTypes.joinToString("", "(", ")") + method.returnType
