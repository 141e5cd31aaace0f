package robotran.assignments.collecting

import robotran.documents.plainFileName
import robotran.languagesupport.SourceFile
import robotran.languagesupport.simpleName
import robotran.programs.languageOfFile
import robotran.programs.support

/**
 * The same file, called like what is in it if its language wants that: platforms and browsers rename what pupils hand
 * in, such as `Fahrt (1).java`, but Java wants the class's name.
 */
fun namedByContent(file: SourceFile): SourceFile =
    languageOfFile(plainFileName(file.name))?.support?.files?.namedByContent(file, stemOf(simpleName(file.name)))
        ?: file
