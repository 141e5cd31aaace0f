package robotran.build.android

import org.codehaus.mojo.animal_sniffer.Clazz
import java.io.File
import java.io.ObjectInputStream
import java.util.zip.GZIPInputStream

/** Adds the public classes of a platform from [file], in the signature format of Animal Sniffer. */
internal fun UsedApi.declareSignatures(file: File) =
    ObjectInputStream(GZIPInputStream(file.inputStream())).use { input ->
        // The list ends with null.
        while (true) {
            val known = input.readObject() as Clazz? ?: break
            // A field has the form `out#Ljava/io/PrintStream;`.
            val members = known.signatures.map { it.substringBefore('#') }.toSet()
            declare(known.name, listOfNotNull(known.superClass) + known.superInterfaces.orEmpty(), members)
        }
    }
