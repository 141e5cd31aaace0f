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
include(":shared:rcx-rom")
include(":shared:robolang")
include(":shared:tinyvm")
include(":shared:workshop")
include(":shared:ui")
include(":cli")
include(":desktopApp")
include(":webApp")
include(":shared:physics")
include(":shared:ecj")
include(":shared:java-compiler")
include(":shared:programs")
include(":shared:json")
include(":shared:simulation")
include(":shared:world")
include(":shared:projects")
include(":shared:documents")
include(":shared:qr-code")
include(":shared:run-control")
include(":shared:world-editing")
include(":shared:lejos-library")
include(":shared:learning")
include(":androidApp")
include(":benchmarks")
include(":shared:text-editing")
