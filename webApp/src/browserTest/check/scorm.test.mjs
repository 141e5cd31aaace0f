// A package of SCORM 2004.
import { testScorm } from '../scorm.mjs';

testScorm('2004', { score: 'cmi.score.raw', status: 'cmi.completion_status', done: 'completed' });
