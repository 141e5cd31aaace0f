package robotran.robolang.translate

/**
 * The three scripts of a kit: each compiles [sources] with leJOS's own compiler script, then links [mainClass] and sends
 * it to the brick with `lejos`. leJOS 2.1 has `lejosc` and `lejosjc`, leJOS 3.0 only `lejosjc`; both have `lejos`
 * (folder `bin` of leJOS's repository at its releases).
 *
 * @property className the program's name.
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
            <condition property="compiler" value="lejosc" else="lejosjc">
                <or>
                    <available file="${'$'}{lejos.bin}/lejosc"/>
                    <available file="${'$'}{lejos.bin}/lejosc.bat"/>
                    <available file="${'$'}{lejos.bin}/lejosc.exe"/>
                </or>
            </condition>

            <target name="compile" description="compiles the program for the brick">
                <exec executable="${'$'}{lejos.bin}/${'$'}{compiler}" osfamily="unix" failonerror="true">
                    <arg line="$options"/>
        @SOURCES@
                </exec>
                <exec executable="cmd" osfamily="windows" failonerror="true">
                    <arg value="/c"/>
                    <arg value="${'$'}{lejos.bin}\${'$'}{compiler}"/>
                    <arg line="$options"/>
        @SOURCES@
                </exec>
            </target>

            <target name="download" depends="compile" description="links it and sends it to the brick">
                <exec executable="${'$'}{lejos.bin}/lejos" osfamily="unix" failonerror="true">
                    <arg value="$mainClass"/>
                </exec>
                <exec executable="cmd" osfamily="windows" failonerror="true">
                    <arg value="/c"/>
                    <arg value="${'$'}{lejos.bin}\lejos"/>
                    <arg value="$mainClass"/>
                </exec>
            </target>
        </project>
        """.trimIndent().replace("@SOURCES@", sourceArguments()) + "\n"

    private fun sourceArguments() = sources.joinToString("\n") { "            <arg value=\"$it\"/>" }

    fun shellScript(): String =
        """
        #!/bin/sh
        # Compiles $className for the brick and sends it there with leJOS's own tools.
        set -e
        cd "${'$'}(dirname "${'$'}0")"
        PATH="${'$'}{LEJOS_HOME:+${'$'}LEJOS_HOME/bin:}${'$'}PATH"
        if command -v lejosc > /dev/null; then
            compiler=lejosc
        elif command -v lejosjc > /dev/null; then
            compiler=lejosjc
        else
            echo "leJOS is not there: set LEJOS_HOME to its folder. README.txt says more." >&2
            exit 1
        fi
        ${'$'}compiler $options ${sources.joinToString(" ", transform = ::word)}
        lejos ${word(mainClass)}
        """.trimIndent() + "\n"

    /** Quoted for a shell: names of nested classes contain a dollar sign. */
    private fun word(name: String) = if ('$' in name) "'$name'" else name

    fun batchFile(): String =
        """
        @echo off
        rem Compiles $className for the brick and sends it there with leJOS's own tools.
        cd /d "%~dp0"
        if not "%LEJOS_HOME%"=="" set PATH=%LEJOS_HOME%\bin;%PATH%
        set COMPILER=lejosc
        where lejosc >nul 2>nul || set COMPILER=lejosjc
        where %COMPILER% >nul 2>nul || (
            echo leJOS is not there: set LEJOS_HOME to its folder. README.txt says more.
            exit /b 1
        )
        call %COMPILER% $options ${sources.joinToString(" ")} || exit /b 1
        call lejos $mainClass
        """.trimIndent() + "\n"
}
