package robotran.javacompiler.support

import robotran.brick.kind.BrickKind
import robotran.javacompiler.edit.JavaSyntax
import robotran.language.ProgramLanguage
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.LanguageSupport
import robotran.languagesupport.ProgramFiles
import robotran.languagesupport.ProgramMeasure

/** Java for leJOS on an RCX, and for leJOS NXJ on an NXT. */
object JavaSupport : LanguageSupport {
    override val language = ProgramLanguage.JAVA
    override val code: CodeSyntax = JavaSyntax
    override val files: ProgramFiles = JavaFiles
    override val measure: ProgramMeasure = JavaMeasure
    override val bricks = BrickKind.entries.filter { it.java != null }.toSet()
    override val hasSlowCompiler = true
    override val namesFileOfLines = true
}
