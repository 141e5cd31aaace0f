package lejos.nxt.comm;

/** What the machine knows of connections between robots; each has a number. */
final class BTLink {
    /** The other robot has not answered yet. */
    static final int WAITING = 0;

    /** Both can send. */
    static final int OPEN = 1;

    private BTLink() {
    }

    static native int name(byte[] into);

    static native boolean isKnown(String name);

    static native int open(String name);

    static native int listen(int mode);

    static native int openCable(String name);

    static native int listenCable(int mode);

    static native int partner(int link, byte[] into);

    static native int status(int link);

    static native int write(int link, byte[] data, int offset, int length);

    static native int read(int link, byte[] data, int offset, int length);

    static native void close(int link);
}
