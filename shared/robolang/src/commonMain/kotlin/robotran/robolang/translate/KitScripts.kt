package robotran.robolang.translate

/**
 * The three scripts of a kit: each compiles [sources], links them with [mainClass] as the start, and sends the program
 * to the brick.
 *
 * @property className the program's name, and that of its `.bin` file.
 * @property mainClass the same with its package, if any.
 */
internal class KitScripts(
    private val className: String,
    private val mainClass: String,
    private val sources: List<String>,
) {
    /** Into the folders of their packages, if any. */
    private val options = if ('.' in mainClass) "-encoding UTF-8 -d ." else "-encoding UTF-8"

    fun antFile(): String =
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <project name="$className" default="download" basedir=".">
            <property environment="env"/>
            <property name="lejos.bin" location="${'$'}{env.LEJOS_HOME}/bin"/>
            <condition property="ending" value=".bat" else="">
                <os family="windows"/>
            </condition>

            <target name="compile" description="compiles the program for the brick">
                <exec executable="${'$'}{lejos.bin}/lejosc${'$'}{ending}" failonerror="true">
                    <arg line="$options"/>
        @SOURCES@
                </exec>
            </target>

            <target name="link" depends="compile" description="puts it together with the classes it uses">
                <exec executable="${'$'}{lejos.bin}/lejoslink${'$'}{ending}" failonerror="true">
                    <arg line="-o $className.bin"/>
                    <arg value="$mainClass"/>
                </exec>
            </target>

            <target name="download" depends="link" description="sends it to the brick">
                <exec executable="${'$'}{lejos.bin}/lejosdl${'$'}{ending}" failonerror="true">
                    <arg value="$className.bin"/>
                </exec>
            </target>
        </project>
        """.trimIndent().replace("@SOURCES@", sourceArguments()) + "\n"

    private fun sourceArguments() = sources.joinToString("\n") { "            <arg value=\"$it\"/>" }

    fun shellScript(): String =
        """
        #!/bin/sh
        # Compiles $className for the brick and sends it there.
        set -e
        cd "${'$'}(dirname "${'$'}0")"
        PATH="${'$'}{LEJOS_HOME:+${'$'}LEJOS_HOME/bin:}${'$'}PATH"
        lejosc $options ${sources.joinToString(" ", transform = ::word)}
        lejoslink -o ${word("$className.bin")} ${word(mainClass)}
        lejosdl ${word("$className.bin")}
        """.trimIndent() + "\n"

    /** Quoted for a shell: names of nested classes contain a dollar sign. */
    private fun word(name: String) = if ('$' in name) "'$name'" else name

    fun batchFile(): String =
        """
        @echo off
        rem Compiles $className for the brick and sends it there.
        cd /d "%~dp0"
        if not "%LEJOS_HOME%"=="" set PATH=%LEJOS_HOME%\bin;%PATH%
        call lejosc $options ${sources.joinToString(" ")} || exit /b 1
        call lejoslink -o $className.bin $mainClass || exit /b 1
        call lejosdl $className.bin
        """.trimIndent() + "\n"
}
