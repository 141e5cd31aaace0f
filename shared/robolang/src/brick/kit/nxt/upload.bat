@echo off
rem Compiles @CLASS@ for the brick and sends it there with leJOS NXJ's own tools.
cd /d "%~dp0"
if not "%NXJ_HOME%"=="" set PATH=%NXJ_HOME%\bin;%PATH%
where nxjc >nul 2>nul || (
    echo leJOS NXJ is not there: set NXJ_HOME to its folder. README.txt says more.
    exit /b 1
)
call nxjc -encoding UTF-8 -d . @SOURCES@ || exit /b 1
call nxjlink -o @CLASS@.nxj @MAIN_CLASS@ || exit /b 1
call nxjupload -r @CLASS@.nxj
