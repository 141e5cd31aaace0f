pluginManagement {
    includeBuild("gradle/build-logic")
    repositories {
        google()
        mavenCentral()
        gradlePluginPortal()
    }
}

dependencyResolutionManagement {
    repositories {
        google()
        mavenCentral()
    }
}

rootProject.name = "robotran"

include(":shared:language")
include(":shared:brick")
include(":shared:language-support")
include(":shared:rcx-rom")
include(":shared:nxt")
include(":shared:hub")
include(":shared:microbit")
include(":shared:robolang")
include(":shared:tinyvm")
include(":shared:lego-firmware")
include(":shared:nqc")
include(":shared:lejos-linker")
include(":shared:tower")
include(":shared:hub-link")
include(":shared:microbit-link")
include(":shared:mpy-compiler")
include(":shared:physics")
include(":shared:ecj")
include(":shared:java-compiler")
include(":shared:programs")
include(":shared:json")
include(":shared:simulation")
include(":shared:scene3d")
include(":shared:world")
include(":shared:projects")
include(":shared:documents")
include(":shared:qr-code")
include(":shared:animated-picture")
include(":shared:run-control")
include(":shared:narration")
include(":shared:run-sound")
include(":shared:editing")
include(":shared:world-editing")
include(":shared:robot-editing")
include(":shared:lejos-library")
include(":shared:nxj-library")
include(":shared:learning")
include(":shared:assignments")
include(":shared:text-editing")
include(":shared:block-editing")

// The modules that a build without the other targets leaves out, see Targets in gradle/build-logic.
if (providers.systemProperty("robotran.targets").get().contains("jvm")) {
    include(":shared:desktop-tower")
    include(":siteServer")
    include(":cli")
}
if (providers.systemProperty("robotran.targets").get().contains("wasm")) {
    include(":wasmTests")
    include(":allWasmTests")
}
if (providers.systemProperty("robotran.targets").get().contains("compose")) {
    include(":shared:workshop")
    include(":shared:uikit")
    include(":shared:ui-common")
    include(":shared:ui-program")
    include(":shared:ui-run")
    include(":shared:ui-world")
    include(":shared:ui-school")
    include(":shared:ui")
    if (providers.systemProperty("robotran.targets").get().contains("jvm")) {
        include(":desktopApp")
    }
    if (providers.systemProperty("robotran.targets").get().contains("wasm")) {
        include(":webApp")
    }
    if (providers.systemProperty("robotran.targets").get().contains("android")) {
        include(":androidApp")
    }
    if (providers.systemProperty("robotran.targets").get().contains("jvm,wasm")) {
        include(":benchmarks")
    }
}
