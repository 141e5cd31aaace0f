package robotran.workshop.state

/** Where a scanner looks for QR codes. */
enum class QrScannerKind {
    /** Before the camera, which shows them live. */
    CAMERA,

    /** In pictures that the user takes or chooses. */
    PICTURES,
}
