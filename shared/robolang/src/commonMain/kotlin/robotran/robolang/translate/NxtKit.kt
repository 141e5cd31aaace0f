package robotran.robolang.translate

/**
 * The files that bring a program for an NXT onto a real one with the tools of leJOS NXJ 0.9.
 *
 * @param className its main class, without package; also the name of the program on the brick.
 * @param sourceName the Robolang program that it is a translation of; null if it was written in Java.
 * @param mainClass the main class with its package.
 * @param javaFiles the names of its sources, without characters that are special to a shell.
 */
internal class NxtKit(
    private val className: String,
    private val sourceName: String?,
    private val mainClass: String = className,
    javaFiles: List<String> = listOf("$className.java"),
) {
    private val sources = javaFiles.joinToString(" ")

    fun files(): List<KitFile> = NxtKitTexts(className, sourceName).readmes() + listOf(
        KitFile("$className/build.xml", antFile()),
        KitFile("$className/upload.sh", shellScript(), isExecutable = true),
        KitFile("$className/upload.bat", batchFile().replace("\n", "\r\n")),
    )

    private fun antFile(): String =
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <project name="$className" default="upload" basedir=".">
            <property environment="env"/>
            <property name="nxj.bin" location="${'$'}{env.NXJ_HOME}/bin"/>

            <macrodef name="nxj">
                <attribute name="tool"/>
                <attribute name="line"/>
                <sequential>
                    <exec executable="${'$'}{nxj.bin}/@{tool}" osfamily="unix" failonerror="true">
                        <arg line="@{line}"/>
                    </exec>
                    <exec executable="cmd" osfamily="windows" failonerror="true">
                        <arg value="/c"/>
                        <arg value="${'$'}{nxj.bin}\@{tool}"/>
                        <arg line="@{line}"/>
                    </exec>
                </sequential>
            </macrodef>

            <target name="link" description="compiles and links the program">
                <nxj tool="nxjc" line="-encoding UTF-8 -d . $sources"/>
                <nxj tool="nxjlink" line="-o $className.nxj $mainClass"/>
            </target>

            <target name="upload" depends="link" description="sends it to the brick and starts it">
                <nxj tool="nxjupload" line="-r $className.nxj"/>
            </target>
        </project>
        """.trimIndent() + "\n"

    private fun shellScript(): String =
        """
        #!/bin/sh
        # Compiles $className for the brick and sends it there with leJOS NXJ's own tools.
        set -e
        cd "${'$'}(dirname "${'$'}0")"
        PATH="${'$'}{NXJ_HOME:+${'$'}NXJ_HOME/bin:}${'$'}PATH"
        if ! command -v nxjc > /dev/null; then
            echo "leJOS NXJ is not there: set NXJ_HOME to its folder. README.txt says more." >&2
            exit 1
        fi
        nxjc -encoding UTF-8 -d . $sources
        nxjlink -o $className.nxj $mainClass
        nxjupload -r $className.nxj
        """.trimIndent() + "\n"

    private fun batchFile(): String =
        """
        @echo off
        rem Compiles $className for the brick and sends it there with leJOS NXJ's own tools.
        cd /d "%~dp0"
        if not "%NXJ_HOME%"=="" set PATH=%NXJ_HOME%\bin;%PATH%
        where nxjc >nul 2>nul || (
            echo leJOS NXJ is not there: set NXJ_HOME to its folder. README.txt says more.
            exit /b 1
        )
        call nxjc -encoding UTF-8 -d . $sources || exit /b 1
        call nxjlink -o $className.nxj $mainClass || exit /b 1
        call nxjupload -r $className.nxj
        """.trimIndent() + "\n"
}
