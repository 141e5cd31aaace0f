package java.lang;

import java.util.Vector;
import lejos.nxt.NXTEvent;

/** Does what is left to do when a program ends. */
class Shutdown {
    private static final int PRIORITY = 9;

    private static Vector<Thread> hooks;
    private static boolean isEnding;

    private Shutdown() {
    }

    static synchronized void add(Thread hook) {
        if (isEnding) throw new IllegalStateException();
        if (hooks == null) {
            hooks = new Vector<Thread>();
            Watcher watcher = new Watcher();
            watcher.setDaemon(true);
            watcher.setPriority(PRIORITY);
            watcher.start();
        }
        hooks.addElement(hook);
    }

    static synchronized boolean remove(Thread hook) {
        if (isEnding) throw new IllegalStateException();
        return hooks != null && hooks.removeElement(hook);
    }

    /** Runs the hooks beside one another, waits for them, and ends the program. */
    static void exit(int code) {
        if (isFirst()) {
            int count = hooks == null ? 0 : hooks.size();
            for (int index = 0; index < count; index++) hooks.elementAt(index).start();
            for (int index = 0; index < count; index++) await(hooks.elementAt(index));
            halt(code);
        }
        while (true) pause();
    }

    static native void halt(int code);

    private static synchronized boolean isFirst() {
        boolean isFirst = !isEnding;
        isEnding = true;
        return isFirst;
    }

    private static void await(Thread hook) {
        while (hook.isAlive()) {
            try {
                hook.join();
            } catch (InterruptedException goOnWaiting) {
                // A program ends only once, and then its hooks have their time.
            }
        }
    }

    private static void pause() {
        try {
            Thread.sleep(1000);
        } catch (InterruptedException goOnWaiting) {
            // Another thread is ending the program.
        }
    }

    /** Waits until the machine wants the program to end: by its buttons, or because all other threads have ended. */
    private static class Watcher extends Thread {
        Watcher() {
        }

        public void run() {
            NXTEvent event = NXTEvent.allocate(NXTEvent.SYSTEM, NXTEvent.SYSTEM_SHUTDOWN, 1);
            while (event.waitEvent(NXTEvent.WAIT_FOREVER) == 0) Thread.yield();
            exit(0);
        }
    }
}
