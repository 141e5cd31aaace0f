@echo off
rem Compiles @CLASS@ for the brick and sends it there with leJOS's own tools.
cd /d "%~dp0"
if not "%LEJOS_HOME%"=="" set PATH=%LEJOS_HOME%\bin;%PATH%
set COMPILER=lejosc
where lejosc >nul 2>nul || set COMPILER=lejosjc
where %COMPILER% >nul 2>nul || (
    echo leJOS is not there: set LEJOS_HOME to its folder. README.txt says more.
    exit /b 1
)
call %COMPILER% @OPTIONS@ @SOURCES@ || exit /b 1
call lejos @MAIN_CLASS@
