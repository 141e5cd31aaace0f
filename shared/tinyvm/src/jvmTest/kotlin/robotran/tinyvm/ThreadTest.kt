package robotran.tinyvm

import robotran.brick.program.ProgramStatus
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class ThreadTest {
    private val counter =
        "static class Counter extends Thread { int from, count; Counter(int from, int count) { this.from = from; " +
            "this.count = count; }" +
            "public void run() { for (int i = 0; i < count; i++) { show(from + i); try { sleep(10); } catch " +
            "(InterruptedException " +
            "e) { show(-1); } } } }"

    @Test
    fun `threads that sleep take turns`() = assertEquals(
        listOf(10, 20, 11, 21, 12, 22),
        shownBy("new Counter(10, 3).start(); new Counter(20, 3).start();", counter),
    )

    @Test
    fun `a higher priority goes first`() = assertEquals(
        listOf(20, 10),
        shownBy(
            "Thread a = new Counter(10, 1); Thread b = new Counter(20, 1); b.setPriority(8); a.start(); b.start();",
            counter,
        ),
    )

    @Test
    fun `busy threads of the same priority share the time`() = assertEquals(
        listOf(1),
        shownBy(
            "Busy a = new Busy(), b = new Busy(); a.setDaemon(true); b.setDaemon(true); a.start(); b.start(); " +
                "Thread.sleep(1000);" +
                "show(a.count > 1000 && b.count > 1000 && a.count < b.count * 2 && b.count < a.count * 2);",
            "static class Busy extends Thread { int count; public void run() { while (true) count++; } }",
        ),
    )

    @Test
    fun `a program ends when only daemons are left`() {
        val ran =
            ran("Thread a = new Counter(10, 1000); a.setDaemon(true); a.start(); Thread.sleep(25); show(1);", counter)
        assertEquals(ProgramStatus.Ended, ran.status)
        assertEquals(listOf(10, 11, 12, 1), ran.rom.shown)
    }

    @Test
    fun `synchronized methods exclude each other`() = assertEquals(
        listOf(1, 2, 1, 2),
        shownBy(
            "final Object lock = new Object(); for (int i = 0; i < 2; i++) new Thread() { public void run() { " +
                "synchronized (lock) { " +
                "show(1);" +
                "try { sleep(50); } catch (InterruptedException e) { } show(2); } } }.start();",
        ),
    )

    @Test
    fun `a thread waits until it is notified`() = assertEquals(
        listOf(1, 2, 3),
        shownBy(
            "final Object lock = new Object(); new Thread() { public void run() { synchronized (lock) { show(2); " +
                "lock.notify(); } } " +
                "}.start();" +
                "synchronized (lock) { show(1); lock.wait(); show(3); }",
        ),
    )

    @Test
    fun `a wait can be over by itself`() = assertEquals(
        listOf(100),
        shownBy(
            "Object lock = new Object(); int before = (int) System.currentTimeMillis(); synchronized (lock) { " +
                "lock.wait(100); }" +
                "show((int) System.currentTimeMillis() - before);",
        ),
    )

    @Test
    fun `an interrupted sleep throws`() = assertEquals(
        listOf(10, -1),
        shownBy("Thread a = new Counter(10, 1); a.start(); Thread.sleep(3); a.interrupt();", counter),
    )

    @Test
    fun `notify without the monitor is an error`() = assertEquals(
        listOf(4),
        shownBy("try { new Object().notify(); } catch (IllegalMonitorStateException e) { show(4); }"),
    )

    @Test
    fun `threads that wait for each other can still be stopped`() {
        val ran =
            ran(
                "final Object a = new Object(), b = new Object(); new Thread() { public void run() { both(b, a); } " +
                    "}.start(); " +
                    "both(a, b);",
                "static void both(Object a, Object b) { synchronized (a) { try { Thread.sleep(20); } catch " +
                    "(InterruptedException e) " +
                    "{ } synchronized (b) { show(9); } } }",
            )
        assertIs<ProgramStatus.Waiting>(ran.status)
        assertEquals(emptyList(), ran.rom.shown)
    }

    @Test
    fun `an exception that nobody catches fails the program with its line`() {
        val failed =
            assertIs<ProgramStatus.Failed>(ran("show(1);\nthrow new IllegalStateException(\"too late\");").status)
        assertEquals(5, failed.failure.sourceLine)
        assertTrue("IllegalStateException (too late)" in failed.failure.message, failed.failure.message)
    }

    @Test
    fun `other threads go on when one fails`() {
        val ran = ran("new Counter(10, 3).start(); Thread.sleep(15); throw new RuntimeException();", counter)
        assertEquals(ProgramStatus.Ended, ran.status)
        assertEquals(
            listOf("RuntimeException"),
            ran.failures.map { it.message.substringAfter("the ").substringBefore('.') },
        )
        assertEquals(listOf(10, 11, 12), ran.rom.shown)
    }

    @Test
    fun `exit ends all threads`() {
        val ran = ran("new Counter(10, 1000).start(); Thread.sleep(5); System.exit(0);", counter)
        assertEquals(ProgramStatus.Ended, ran.status)
    }

    @Test
    fun `what changes at a sensor wakes who polls`() {
        val body = "Sensor.S1.readValue(); Poll poll = new Poll(); Sensor.S1.setPreviousValue(32); " +
            "show(poll.poll(Poll.ALL_SENSORS, 0));"
        assertEquals(listOf(7), ran(body).rom.shown)
    }
}
