from fake_hub import advance, ask, passing, state, whole


def wait(time):
    return passing(max(0, whole(time)))


class StopWatch:
    def __init__(self):
        self.start = state.clock
        self.paused_at = None

    def time(self):
        ask()
        return (state.clock if self.paused_at is None else self.paused_at) - self.start

    def reset(self):
        self.start = state.clock
        if self.paused_at is not None:
            self.paused_at = state.clock

    def pause(self):
        if self.paused_at is None:
            self.paused_at = state.clock

    def resume(self):
        if self.paused_at is not None:
            self.start += state.clock - self.paused_at
            self.paused_at = None


def multitask(*tasks, race=False):
    return together([iter(task) for task in tasks], race)


def together(tasks, race):
    results = [None] * len(tasks)
    alive = list(range(len(tasks)))
    while alive:
        ends = []
        for place in list(alive):
            try:
                ends.append(next(tasks[place]))
            except StopIteration as end:
                results[place] = end.value
                alive.remove(place)
                if race:
                    for other in alive:
                        tasks[other].close()
                    return tuple(results)
        if alive:
            yield min(ends)
    return tuple(results)


def run_task(task=None):
    if task is None:
        return state.is_in_tasks
    if state.is_in_tasks:
        raise RuntimeError("Run loop already active.")
    steps = iter(task)
    state.is_in_tasks = True
    try:
        while True:
            until = next(steps)
            # Until then nothing happens, for every task waits.
            advance(1 if state.is_renewed else max(1, until - state.clock))
            state.is_renewed = False
    except StopIteration:
        return None
    finally:
        state.is_in_tasks = False
